// Lab 3 - Rasterisation
#include <iostream>
#include <vector>
#include <climits>
#include <algorithm>
#include <glm/glm.hpp>
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"

using namespace std;
using glm::vec3;
using glm::ivec2;
using glm::mat3;

// ----------------------------------------------------------------------------
// STRUCTS

struct Pixel
{
	int x;
	int y;
	float zinv;
	vec3 pos3d;      // position in the world, divided by z
};

struct Vertex
{
	vec3 position;
};

// ----------------------------------------------------------------------------
// GLOBAL VARIABLES

const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;
SDL_Surface* screen;
int t;
vector<Triangle> triangles;

float focalLength = 500;
vec3 cameraPos( 0, 0, -3.001f );
mat3 R;
float yaw = 0;

vec3 lightPos( 0, -0.5f, -0.7f );
vec3 lightPower = 14.0f * vec3( 1, 1, 1 );
vec3 indirectLightPowerPerArea = 0.5f * vec3( 1, 1, 1 );

float depthBuffer[SCREEN_HEIGHT][SCREEN_WIDTH];

vec3 currentNormal;
vec3 currentReflectance;

// ----------------------------------------------------------------------------
// FUNCTIONS

void Update();
void Draw();
void VertexShader( const Vertex& v, Pixel& p );
void PixelShader( const Pixel& p );
void Interpolate( Pixel a, Pixel b, vector<Pixel>& result );
void ComputePolygonRows( const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels );
void DrawPolygonRows( const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels );
void DrawPolygon( const vector<Vertex>& vertices );
void UpdateRotation();

int main( int argc, char* argv[] )
{
	LoadTestModel( triangles );
	screen = InitializeSDL( SCREEN_WIDTH, SCREEN_HEIGHT );
	t = SDL_GetTicks();
	UpdateRotation();

	while( NoQuitMessageSDL() )
	{
		Update();
		Draw();
	}

	SDL_SaveBMP( screen, "screenshot.bmp" );
	return 0;
}

void UpdateRotation()
{
	float c = cos( yaw );
	float s = sin( yaw );
	R[0] = vec3( c, 0, -s );
	R[1] = vec3( 0, 1, 0 );
	R[2] = vec3( s, 0, c );
}

void Update()
{
	int t2 = SDL_GetTicks();
	float dt = float( t2 - t );
	t = t2;
	cout << "Render time: " << dt << " ms." << endl;

	float step = 0.1f;
	vec3 right = R[0];
	vec3 down = R[1];
	vec3 forward = R[2];

	Uint8* keystate = SDL_GetKeyState( 0 );

	if( keystate[SDLK_UP] )
		cameraPos += step * forward;
	if( keystate[SDLK_DOWN] )
		cameraPos -= step * forward;
	if( keystate[SDLK_RIGHT] )
		yaw += step;
	if( keystate[SDLK_LEFT] )
		yaw -= step;
	if( keystate[SDLK_w] )
		lightPos += step * forward;
	if( keystate[SDLK_s] )
		lightPos -= step * forward;
	if( keystate[SDLK_d] )
		lightPos += step * right;
	if( keystate[SDLK_a] )
		lightPos -= step * right;
	if( keystate[SDLK_e] )
		lightPos += step * down;
	if( keystate[SDLK_q] )
		lightPos -= step * down;

	UpdateRotation();
}

void Draw()
{
	SDL_FillRect( screen, 0, 0 );
	if( SDL_MUSTLOCK( screen ) )
		SDL_LockSurface( screen );

	for( int y=0; y<SCREEN_HEIGHT; ++y )
		for( int x=0; x<SCREEN_WIDTH; ++x )
			depthBuffer[y][x] = 0;

	for( size_t i=0; i<triangles.size(); ++i )
	{
		vector<Vertex> vertices( 3 );
		vertices[0].position = triangles[i].v0;
		vertices[1].position = triangles[i].v1;
		vertices[2].position = triangles[i].v2;

		currentNormal = triangles[i].normal;
		currentReflectance = triangles[i].color;

		DrawPolygon( vertices );
	}

	if( SDL_MUSTLOCK( screen ) )
		SDL_UnlockSurface( screen );

	SDL_UpdateRect( screen, 0, 0, 0, 0 );
}

void VertexShader( const Vertex& v, Pixel& p )
{
	vec3 pos = ( v.position - cameraPos ) * R;
	p.zinv = 1.0f / pos.z;
	p.x = int( focalLength * pos.x * p.zinv ) + SCREEN_WIDTH / 2;
	p.y = int( focalLength * pos.y * p.zinv ) + SCREEN_HEIGHT / 2;
	p.pos3d = v.position * p.zinv;
}

void Interpolate( Pixel a, Pixel b, vector<Pixel>& result )
{
	int N = result.size();
	float steps = float( max( N-1, 1 ) );

	float stepX = ( b.x - a.x ) / steps;
	float stepY = ( b.y - a.y ) / steps;
	float stepZ = ( b.zinv - a.zinv ) / steps;
	vec3 stepPos = ( b.pos3d - a.pos3d ) / steps;

	float x = a.x;
	float y = a.y;
	float zinv = a.zinv;
	vec3 pos = a.pos3d;

	for( int i=0; i<N; ++i )
	{
		result[i].x = int( x );
		result[i].y = int( y );
		result[i].zinv = zinv;
		result[i].pos3d = pos;
		x += stepX;
		y += stepY;
		zinv += stepZ;
		pos += stepPos;
	}
}

void ComputePolygonRows( const vector<Pixel>& vertexPixels, vector<Pixel>& leftPixels, vector<Pixel>& rightPixels )
{
	// 1. Find max and min y-value of the polygon and compute the number of rows it occupies.
	int minY = INT_MAX;
	int maxY = -INT_MAX;
	for( size_t i=0; i<vertexPixels.size(); ++i )
	{
		minY = min( minY, vertexPixels[i].y );
		maxY = max( maxY, vertexPixels[i].y );
	}
	int ROWS = maxY - minY + 1;

	// 2. Resize leftPixels and rightPixels so that they have an element for each row.
	leftPixels.resize( ROWS );
	rightPixels.resize( ROWS );

	// 3. Initialize the x-coordinates to really large and really small values.
	for( int i=0; i<ROWS; ++i )
	{
		leftPixels[i].x = INT_MAX;
		leftPixels[i].y = minY + i;
		rightPixels[i].x = -INT_MAX;
		rightPixels[i].y = minY + i;
	}

	// 4. Loop through all edges and update the rows.
	int V = vertexPixels.size();
	for( int i=0; i<V; ++i )
	{
		Pixel a = vertexPixels[i];
		Pixel b = vertexPixels[( i+1 ) % V];
		int n = max( abs( a.x - b.x ), abs( a.y - b.y ) ) + 1;
		vector<Pixel> line( n );
		Interpolate( a, b, line );

		for( int j=0; j<n; ++j )
		{
			int row = line[j].y - minY;
			if( row < 0 || row >= ROWS )
				continue;        // rounding can put the end of a line one row off
			if( line[j].x < leftPixels[row].x )
				leftPixels[row] = line[j];
			if( line[j].x > rightPixels[row].x )
				rightPixels[row] = line[j];
		}
	}
}

void DrawPolygonRows( const vector<Pixel>& leftPixels, const vector<Pixel>& rightPixels )
{
	for( size_t i=0; i<leftPixels.size(); ++i )
	{
		if( leftPixels[i].x > rightPixels[i].x )
			continue;
		vector<Pixel> row( rightPixels[i].x - leftPixels[i].x + 1 );
		Interpolate( leftPixels[i], rightPixels[i], row );
		for( size_t j=0; j<row.size(); ++j )
			PixelShader( row[j] );
	}
}

void DrawPolygon( const vector<Vertex>& vertices )
{
	for( size_t i=0; i<vertices.size(); ++i )
	{
		vec3 p = ( vertices[i].position - cameraPos ) * R;
		if( p.z < 0.3f )
			return;
	}

	vector<Pixel> vertexPixels( vertices.size() );
	for( size_t i=0; i<vertices.size(); ++i )
		VertexShader( vertices[i], vertexPixels[i] );

	vector<Pixel> leftPixels;
	vector<Pixel> rightPixels;
	ComputePolygonRows( vertexPixels, leftPixels, rightPixels );
	DrawPolygonRows( leftPixels, rightPixels );
}

void PixelShader( const Pixel& p )
{
	if( p.x < 0 || p.x >= SCREEN_WIDTH || p.y < 0 || p.y >= SCREEN_HEIGHT )
		return;

	if( p.zinv > depthBuffer[p.y][p.x] )
	{
		depthBuffer[p.y][p.x] = p.zinv;

		vec3 pos = p.pos3d / p.zinv;
		vec3 r = lightPos - pos;
		float r2 = glm::dot( r, r );
		vec3 rDir = glm::normalize( r );
		float cosine = max( glm::dot( rDir, currentNormal ), 0.0f );
		vec3 D = lightPower * cosine / ( 4.0f * 3.14159265f * r2 );

		vec3 color = currentReflectance * ( D + indirectLightPowerPerArea );
		PutPixelSDL( screen, p.x, p.y, color );
	}
}

// Lab 3, Rasterization, part 1
//
// This is my first C++ program so I write down what everything does.

#include <iostream>      // for cout
#include <vector>        // for vector
#include <glm/glm.hpp>   // for vec3, ivec2, mat3
#include <SDL.h>
#include "SDLauxiliary.h"
#include "TestModel.h"

using namespace std;
using glm::vec3;
using glm::ivec2;
using glm::mat3;

// size of the window
const int SCREEN_WIDTH = 500;
const int SCREEN_HEIGHT = 500;

// the window
SDL_Surface* screen;

// time of the last frame
int t;

// all the triangles of the room
vector<Triangle> triangles;

// The camera. It is 3.001 away and not 3 because then the room just fits in the window.
vec3 cameraPos( 0, 0, -3.001 );

// focal length, if it is as large as the window the field of view is 53 degrees
float focalLength = 500;

// how much the camera is turned, in radians
float yaw = 0;

// the rotation matrix. Has to be computed again when yaw changes!
mat3 R;

// declarations, so that main can be at the top
void Update();
void Draw();
void VertexShader( const vec3& v, ivec2& p );
void ComputeRotation();

int main( int argc, char* argv[] )
{
	LoadTestModel( triangles );                              // fills the vector
	screen = InitializeSDL( SCREEN_WIDTH, SCREEN_HEIGHT );   // opens the window
	t = SDL_GetTicks();	// Set start value for timer.
	ComputeRotation();

	// runs until the window is closed
	while( NoQuitMessageSDL() )
	{
		Update();
		Draw();
	}

	// save the last picture for the report
	SDL_SaveBMP( screen, "screenshot.bmp" );
	return 0;
}

// makes R from yaw
void ComputeRotation()
{
	// glm matrices are indexed by column first!
	R[0][0] = cos( yaw );
	R[0][1] = 0;
	R[0][2] = -sin( yaw );

	R[1][0] = 0;
	R[1][1] = 1;
	R[1][2] = 0;

	R[2][0] = sin( yaw );
	R[2][1] = 0;
	R[2][2] = cos( yaw );
}

void Update()
{
	// Compute frame time:
	int t2 = SDL_GetTicks();
	float dt = float(t2-t);
	t = t2;
	cout << "Render time: " << dt << " ms." << endl;

	// which keys are down right now
	Uint8* keystate = SDL_GetKeyState( 0 );

	// forward and backward
	if( keystate[SDLK_UP] )
	{
		cameraPos.x += R[2][0] * 0.1f;
		cameraPos.z += R[2][2] * 0.1f;
	}

	if( keystate[SDLK_DOWN] )
	{
		cameraPos.x -= R[2][0] * 0.1f;
		cameraPos.z -= R[2][2] * 0.1f;
	}

	// turn to the right
	if( keystate[SDLK_RIGHT] )
	{
		yaw = yaw + 0.1f;
		ComputeRotation();
	}

	// turn to the left
	if( keystate[SDLK_LEFT] )
	{
		yaw = yaw - 0.1f;
		ComputeRotation();
	}
}

void Draw()
{
	// make everything black
	SDL_FillRect( screen, 0, 0 );

	if( SDL_MUSTLOCK(screen) )
		SDL_LockSurface(screen);

	// go through all triangles
	for( size_t i=0; i<triangles.size(); ++i )
	{
		// the three corners
		vector<vec3> vertices(3);
		vertices[0] = triangles[i].v0;
		vertices[1] = triangles[i].v1;
		vertices[2] = triangles[i].v2;

		// one white dot for each corner
		for( int v=0; v<3; ++v )
		{
			// is it in front of the camera? otherwise it must not be drawn
			vec3 fromCamera = ( vertices[v] - cameraPos ) * R;
			if( fromCamera.z <= 0 )
				continue;

			ivec2 projPos;
			VertexShader( vertices[v], projPos );

			// is it in the window?
			if( projPos.x < 0 || projPos.x >= SCREEN_WIDTH )
				continue;
			if( projPos.y < 0 || projPos.y >= SCREEN_HEIGHT )
				continue;

			vec3 color( 1, 1, 1 );
			PutPixelSDL( screen, projPos.x, projPos.y, color );
		}
	}

	if( SDL_MUSTLOCK(screen) )
		SDL_UnlockSurface(screen);

	// show it
	SDL_UpdateRect( screen, 0, 0, 0, 0 );
}

// takes the 3D position of a vertex v and computes its 2D image position p
void VertexShader( const vec3& v, ivec2& p )
{
	// move and turn the world so that the camera is at the origin
	vec3 P = ( v - cameraPos ) * R;

	// the pinhole camera
	float x = focalLength * P.x / P.z + SCREEN_WIDTH / 2;
	float y = focalLength * P.y / P.z + SCREEN_HEIGHT / 2;

	// pixels are whole numbers
	p.x = x;
	p.y = y;
}

using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity.Robot
{
    /// <summary>
    /// Draws the axes of a URDF frame in the editor's scene view, each with its letter: x (forward) in red, y (left) in green, z (up) in blue.
    /// </summary>
    static class FrameGizmo
    {
        // Strokes of the letters, two points per stroke, in a unit square with the origin at its lower left corner.
        static readonly Vector2[] X = { new Vector2(0, 0), new Vector2(1, 1), new Vector2(0, 1), new Vector2(1, 0) };

        static readonly Vector2[] Y =
        {
            new Vector2(0.5f, 0), new Vector2(0.5f, 0.5f), new Vector2(0.5f, 0.5f), new Vector2(0, 1), new Vector2(0.5f, 0.5f), new Vector2(1, 1),
        };

        static readonly Vector2[] Z =
        {
            new Vector2(0, 1), new Vector2(1, 1), new Vector2(1, 1), new Vector2(0, 0), new Vector2(0, 0), new Vector2(1, 0),
        };

        /// <summary>Draws the axes of a frame.</summary>
        /// <param name="frame">Transform that represents the frame in Unity's axes.</param>
        /// <param name="metres">Length of an axis in metres.</param>
        public static void Draw(Transform frame, float metres)
        {
            Gizmos.matrix = Matrix4x4.TRS(frame.position, frame.rotation, new Vector3(metres, metres, metres));
            DrawAxis((1, 0, 0), Color.red, X);
            DrawAxis((0, 1, 0), Color.green, Y);
            DrawAxis((0, 0, 1), Color.blue, Z);
        }

        /// <summary>Draws a printed code: its edges, and a line from its centre that points out of the print.</summary>
        /// <param name="frame">Transform that represents the base frame in Unity's axes.</param>
        /// <param name="code">Pose of the marker frame in the base frame.</param>
        /// <param name="metres">Length of an edge of the code in metres.</param>
        public static void DrawCode(Transform frame, in RigidTransform code, float metres)
        {
            var pose = UnityPoses.ToWorld(code);
            Gizmos.matrix = Matrix4x4.TRS(frame.position, frame.rotation, Vector3.one) * Matrix4x4.TRS(
                pose.position, pose.rotation, new Vector3(metres, metres, metres) / 2);
            Gizmos.color = new Color(1, 0.9f, 0);
            var (right, up) = (UnityFrame.DirectionToUnity((1, 0, 0)).Vector(), UnityFrame.DirectionToUnity((0, 1, 0)).Vector());
            Gizmos.DrawLine(-right - up, right - up);
            Gizmos.DrawLine(right - up, right + up);
            Gizmos.DrawLine(right + up, up - right);
            Gizmos.DrawLine(up - right, -right - up);
            Gizmos.DrawLine(Vector3.zero, UnityFrame.DirectionToUnity((0, 0, 1)).Vector());
        }

        static void DrawAxis((double, double, double) axis, Color colour, Vector2[] letter)
        {
            var tip = UnityFrame.DirectionToUnity(axis).Vector();
            Gizmos.color = colour;
            Gizmos.DrawLine(Vector3.zero, tip);
            // Draws the letter upright beside the tip of the axis.
            var corner = tip * 1.1f - new Vector3(0.05f, 0.05f, 0);
            for (var i = 0; i < letter.Length; i += 2)
                Gizmos.DrawLine(corner + (Vector3)letter[i] * 0.1f, corner + (Vector3)letter[i + 1] * 0.1f);
        }
    }
}

using Nowpose.Kinematics;
using UnityEngine;

namespace Nowpose.Unity
{
    /// <summary>The axes of a URDF frame in the editor's view: x forward in red, y left in green, z up in blue, each with its letter.</summary>
    static class FrameGizmo
    {
        // Strokes of the letters in a unit square, from the lower left corner: two corners each.
        static readonly Vector2[] X = { new Vector2(0, 0), new Vector2(1, 1), new Vector2(0, 1), new Vector2(1, 0) };

        static readonly Vector2[] Y =
        {
            new Vector2(0.5f, 0), new Vector2(0.5f, 0.5f), new Vector2(0.5f, 0.5f), new Vector2(0, 1), new Vector2(0.5f, 0.5f), new Vector2(1, 1),
        };

        static readonly Vector2[] Z =
        {
            new Vector2(0, 1), new Vector2(1, 1), new Vector2(1, 1), new Vector2(0, 0), new Vector2(0, 0), new Vector2(1, 0),
        };

        /// <param name="frame">Its axes are Unity's of the frame.</param>
        /// <param name="metres">Length of an axis.</param>
        public static void Draw(Transform frame, float metres)
        {
            Gizmos.matrix = Matrix4x4.TRS(frame.position, frame.rotation, new Vector3(metres, metres, metres));
            DrawAxis((1, 0, 0), Color.red, X);
            DrawAxis((0, 1, 0), Color.green, Y);
            DrawAxis((0, 0, 1), Color.blue, Z);
        }

        static void DrawAxis((double, double, double) axis, Color colour, Vector2[] letter)
        {
            var tip = UnityFrame.DirectionToUnity(axis).Vector();
            Gizmos.color = colour;
            Gizmos.DrawLine(Vector3.zero, tip);
            // Upright, facing whoever looks at the frame from behind or before; beside the tip of the axis.
            var corner = tip * 1.1f - new Vector3(0.05f, 0.05f, 0);
            for (var i = 0; i < letter.Length; i += 2)
                Gizmos.DrawLine(corner + (Vector3)letter[i] * 0.1f, corner + (Vector3)letter[i + 1] * 0.1f);
        }
    }
}

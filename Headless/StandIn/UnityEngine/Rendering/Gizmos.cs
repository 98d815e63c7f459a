namespace UnityEngine;

/// <summary>Draws nothing, because there is no scene view.</summary>
public sealed class Gizmos
{
    public static Color color { get; set; } = Color.white;
    public static Matrix4x4 matrix { get; set; } = Matrix4x4.identity;

    public static void DrawLine(Vector3 from, Vector3 to) { }
}

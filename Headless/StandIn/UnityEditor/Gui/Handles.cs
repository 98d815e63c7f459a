namespace UnityEditor;

public sealed class Handles
{
    public static Color color { get; set; } = Color.white;

    public static void DrawAAPolyLine(float width, int actualNumberOfPoints, params Vector3[] points) =>
        GuiRecorder.Lines.Add(points.AsSpan(0, actualNumberOfPoints).ToArray());
}

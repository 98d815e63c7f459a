namespace UnityEditor;

public sealed class EditorGUIUtility : GUIUtility
{
    public static float singleLineHeight => 18;
    public static string systemCopyBuffer { get; set; } = "";
}

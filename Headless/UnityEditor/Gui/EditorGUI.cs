using UnityEngine;

namespace UnityEditor;

public sealed class EditorGUI
{
    public static void DrawRect(Rect rect, Color color) { }
}

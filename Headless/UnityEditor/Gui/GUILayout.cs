using UnityEditor;

namespace UnityEngine;

public class GUILayout
{
    public static bool Button(string text, params GUILayoutOption[] options) => GuiRecorder.Button(text);
    public static void FlexibleSpace() { }
    public static void Space(float pixels) { }
    public static GUILayoutOption Width(float width) => new GUILayoutOption();
}

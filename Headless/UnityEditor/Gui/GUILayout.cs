using UnityEditor;

namespace UnityEngine;

public class GUILayout
{
    public static bool Button(string text, params GUILayoutOption[] options) => GuiRecorder.Button(text);
    public static GUILayoutOption Width(float width) => new GUILayoutOption();
}

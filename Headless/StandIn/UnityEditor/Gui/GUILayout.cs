using UnityEditor;

namespace UnityEngine;

public class GUILayout
{
    public static bool Button(string text, params GUILayoutOption[] options) => GuiRecorder.Button(text);

    public static int Toolbar(int selected, string[] texts, params GUILayoutOption[] options)
    {
        for (var i = 0; i < texts.Length; i++)
            if (GuiRecorder.Button(texts[i])) selected = i;
        return selected;
    }

    public static GUILayoutOption Width(float width) => new GUILayoutOption();
}

public sealed class GUILayoutOption
{
    internal GUILayoutOption() { }
}

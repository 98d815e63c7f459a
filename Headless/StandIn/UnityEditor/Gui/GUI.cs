using UnityEditor;

namespace UnityEngine;

public class GUI
{
    public static void Label(Rect position, string text, GUIStyle style) => GuiRecorder.Text(text);

    public abstract class Scope : IDisposable
    {
        protected abstract void CloseScope();

        public void Dispose() => CloseScope();
    }
}

public class GUIContent
{
    public GUIContent(string text) => this.text = text;

    public string text { get; set; }
}

public sealed class GUIStyle
{
    internal GUIStyle() { }
}

public class GUIUtility
{
}

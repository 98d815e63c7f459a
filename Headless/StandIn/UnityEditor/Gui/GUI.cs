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

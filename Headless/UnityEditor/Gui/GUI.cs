using System;
using UnityEditor;

namespace UnityEngine;

public class GUI
{
    public static bool enabled { get; set; } = true;
    public static Color color { get; set; } = Color.white;

    public static void Label(Rect position, string text) => GuiRecorder.Text(text);
    public static void Label(Rect position, string text, GUIStyle style) => GuiRecorder.Text(text);

    public abstract class Scope : IDisposable
    {
        protected abstract void CloseScope();

        public void Dispose() => CloseScope();
    }
}

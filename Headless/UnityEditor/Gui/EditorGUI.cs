using System;
using UnityEngine;

namespace UnityEditor;

public sealed class EditorGUI
{
    public static void DrawRect(Rect rect, Color color) { }

    public struct DisabledScope : IDisposable
    {
        readonly bool _before;

        public DisabledScope(bool disabled)
        {
            _before = GUI.enabled;
            GUI.enabled &= !disabled;
        }

        public void Dispose() => GUI.enabled = _before;
    }
}

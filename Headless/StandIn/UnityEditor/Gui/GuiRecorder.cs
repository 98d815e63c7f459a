using System.Collections.Generic;
using UnityEngine;

namespace UnityEditor;

/// <summary>Records what editor code draws, for tests, and simulates clicks.</summary>
static class GuiRecorder
{
    /// <summary>Labels, boxes and buttons, in the order they were drawn.</summary>
    internal static List<string> Texts { get; } = new List<string>();

    /// <summary>Texts of the buttons that could be clicked.</summary>
    internal static List<string> Buttons { get; } = new List<string>();

    /// <summary>The points of each line.</summary>
    internal static List<Vector3[]> Lines { get; } = new List<Vector3[]>();

    /// <summary>Names of the serialised fields that were drawn.</summary>
    internal static List<string> Properties { get; } = new List<string>();

    /// <summary>Text of the button whose next drawing reports a click.</summary>
    internal static string Click { get; set; }

    /// <summary>The entries of each drop-down.</summary>
    internal static List<string[]> Choices { get; } = new List<string[]>();

    /// <summary>The entry selected in the next drop-down that contains it.</summary>
    internal static string Choose { get; set; }

    internal static void Clear()
    {
        Texts.Clear();
        Buttons.Clear();
        Lines.Clear();
        Properties.Clear();
        Choices.Clear();
        Click = null;
        Choose = null;
    }

    internal static void Text(string text) => Texts.Add(text);

    internal static bool Button(string text)
    {
        Texts.Add(text);
        Buttons.Add(text);
        if (Click != text) return false;

        Click = null;
        return true;
    }
}

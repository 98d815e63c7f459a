namespace UnityEditor;

/// <summary>Records the controls that editor code draws, and simulates clicks, for tests.</summary>
static class GuiRecorder
{
    /// <summary>Strings of the labels, boxes and buttons in the order in which they were drawn.</summary>
    internal static List<string> Texts { get; } = new List<string>();

    /// <summary>Captions of the drawn buttons.</summary>
    internal static List<string> Buttons { get; } = new List<string>();

    /// <summary>Points of each drawn line.</summary>
    internal static List<Vector3[]> Lines { get; } = new List<Vector3[]>();

    /// <summary>Names of the drawn serialised fields.</summary>
    internal static List<string> Properties { get; } = new List<string>();

    /// <summary>Text of the button to click. The next time the button is drawn, it reports a click.</summary>
    internal static string Click { get; set; }

    /// <summary>Entries of each drawn drop-down list.</summary>
    internal static List<string[]> Choices { get; } = new List<string[]>();

    /// <summary>Entry to select in the next drop-down list that contains it.</summary>
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

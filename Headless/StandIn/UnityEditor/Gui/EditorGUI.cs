namespace UnityEditor;

public sealed class EditorGUI
{
    static bool _hasChanged;

    public static bool showMixedValue { get; set; }

    public static void DrawRect(Rect rect, Color color) { }

    public static GUIContent BeginProperty(Rect totalPosition, GUIContent label, SerializedProperty property) => label;

    public static void EndProperty() { }

    public static void BeginChangeCheck() => _hasChanged = false;

    public static bool EndChangeCheck() => _hasChanged;

    public static int Popup(Rect position, GUIContent label, int selectedIndex, GUIContent[] displayedOptions)
    {
        var options = displayedOptions.Select(o => o.text).ToArray();
        GuiRecorder.Text(label.text + ": " + (showMixedValue ? "—" : options[selectedIndex]));
        GuiRecorder.Choices.Add(options);
        var chosen = Array.IndexOf(options, GuiRecorder.Choose);
        if (chosen < 0) return selectedIndex;

        GuiRecorder.Choose = null;
        _hasChanged = true;
        return chosen;
    }
}

public enum MessageType
{
    None = 0,
    Info = 1,
    Warning = 2,
    Error = 3,
}

namespace UnityEditor;

public sealed class EditorGUILayout
{
    public static void HelpBox(string message, MessageType type) => GuiRecorder.Text(message);

    public static void LabelField(string label, GUIStyle style, params GUILayoutOption[] options) => GuiRecorder.Text(label);
    public static void LabelField(string label, string label2, params GUILayoutOption[] options) => GuiRecorder.Text(label + ": " + label2);

    public static Rect GetControlRect(bool hasLabel, float height, params GUILayoutOption[] options) => new Rect(0, 0, 300, height);

    public static bool PropertyField(SerializedProperty property, params GUILayoutOption[] options)
    {
        GuiRecorder.Properties.Add(property.propertyPath);
        property.Drawer?.OnGUI(GetControlRect(true, 18), property, new GUIContent(property.propertyPath));
        return false;
    }

    public static void Space() { }

    public class HorizontalScope : GUI.Scope
    {
        public HorizontalScope(params GUILayoutOption[] options) { }

        protected override void CloseScope() { }
    }

    public class VerticalScope : GUI.Scope
    {
        public VerticalScope(GUIStyle style, params GUILayoutOption[] options) { }

        protected override void CloseScope() { }
    }

    public class ScrollViewScope : GUI.Scope
    {
        public ScrollViewScope(Vector2 scrollPosition, params GUILayoutOption[] options) => this.scrollPosition = scrollPosition;

        public Vector2 scrollPosition { get; protected set; }

        protected override void CloseScope() { }
    }
}

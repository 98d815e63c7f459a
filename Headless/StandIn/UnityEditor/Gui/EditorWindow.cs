namespace UnityEditor;

public class EditorWindow : ScriptableObject
{
    public Vector2 minSize { get; set; }

    /// <summary>Number of calls of <see cref="Repaint"/>.</summary>
    internal int Repaints { get; private set; }

    internal string Title { get; private set; }

    public static T GetWindow<T>(string title) where T : EditorWindow
    {
        var window = World.Current.Objects.OfType<T>().FirstOrDefault() ?? CreateInstance<T>();
        window.Title = title;
        return window;
    }

    public void Repaint() => Repaints++;
}

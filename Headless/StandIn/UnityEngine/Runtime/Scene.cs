namespace UnityEngine.SceneManagement;

public struct Scene
{
    readonly SceneContent _content;

    internal Scene(SceneContent content) => _content = content;

    public readonly int handle => _content?.Handle ?? 0;

    public readonly int buildIndex => World.Current.Scenes.BuildList.Index;

    public readonly bool IsValid() => _content is { IsLoaded: true };

    public readonly GameObject[] GetRootGameObjects() =>
        IsValid() ? new List<GameObject>(_content.Roots).ToArray() : throw new ArgumentException("The scene is invalid.");

    public static bool operator ==(Scene lhs, Scene rhs) => lhs.handle == rhs.handle;
    public static bool operator !=(Scene lhs, Scene rhs) => lhs.handle != rhs.handle;
    public override readonly bool Equals(object other) => other is Scene s && this == s;
    public override readonly int GetHashCode() => handle;
}

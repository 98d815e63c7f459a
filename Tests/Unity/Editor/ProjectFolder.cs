namespace Nowpose.Unity.Tests.Editor;

/// <summary>A temporary folder for a Unity project. Dispose deletes it.</summary>
sealed class ProjectFolder : IDisposable
{
    public string Root { get; } = Directory.CreateTempSubdirectory("nowpose-project-").FullName;

    public void Write(string path, string text) => Write(path, System.Text.Encoding.UTF8.GetBytes(text));

    public void Write(string path, byte[] content)
    {
        var full = Path.Combine(Root, path);
        Directory.CreateDirectory(Path.GetDirectoryName(full));
        File.WriteAllBytes(full, content);
    }

    public string Read(string path) => File.ReadAllText(Path.Combine(Root, path));

    public void Dispose() => Directory.Delete(Root, recursive: true);
}

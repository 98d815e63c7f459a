namespace Nowpose.Unity.Tests.Editor;

/// <summary>A Unity project of its own, in a folder that is removed afterwards.</summary>
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

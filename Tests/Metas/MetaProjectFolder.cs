namespace Nowpose.Headless.Tests.Metas;

/// <summary>A Unity project in a temporary folder. Dispose deletes the folder.</summary>
sealed class MetaProjectFolder : IDisposable
{
    public MetaProjectFolder()
    {
        Root = Directory.CreateTempSubdirectory("nowpose-metas-").FullName;
        Add("Packages/manifest.json", "{}");
        Add("ProjectSettings/ProjectVersion.txt", "m_EditorVersion: 2022.3.62f1\n");
    }

    public string Root { get; }

    public void Dispose() => Directory.Delete(Root, recursive: true);

    public void Add(string path, string text = "")
    {
        Directory.CreateDirectory(Path.GetDirectoryName(Full(path)));
        File.WriteAllText(Full(path), text);
    }

    public string Read(string path) => File.ReadAllText(Full(path));

    public void Replace(string path, string old, string text) => File.WriteAllText(Full(path), Read(path).Replace(old, text));

    public void Delete(string path) => File.Delete(Full(path));

    public IEnumerable<string> Metas()
    {
        return Directory.EnumerateFiles(Root, "*.meta", SearchOption.AllDirectories)
            .Select(f => Path.GetRelativePath(Root, f).Replace('\\', '/')).Order(StringComparer.Ordinal);
    }

    string Full(string path) => Path.Combine(Root, path);
}

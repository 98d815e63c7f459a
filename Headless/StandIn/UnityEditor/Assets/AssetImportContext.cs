namespace UnityEditor.AssetImporters;

public class AssetImportContext
{
    readonly List<Object> _objects = new List<Object>();
    readonly HashSet<string> _identifiers = new HashSet<string>();

    internal AssetImportContext(string assetPath) => this.assetPath = assetPath;

    public string assetPath { get; }
    public Object mainObject { get; private set; }

    /// <summary>Error messages of the import, oldest first.</summary>
    internal List<string> Errors { get; } = new List<string>();

    internal List<string> Warnings { get; } = new List<string>();

    /// <summary>Paths of the assets whose import results this import uses.</summary>
    internal List<string> ArtifactDependencies { get; } = new List<string>();

    /// <summary>Paths of files that this import reads or, if they do not exist yet, would read.</summary>
    internal List<string> SourceDependencies { get; } = new List<string>();

    internal IReadOnlyCollection<string> Identifiers => _identifiers;

    public void AddObjectToAsset(string identifier, Object obj)
    {
        if (!obj) throw new ArgumentNullException(nameof(obj), "Cannot add a null object to an asset");
        if (!_identifiers.Add(identifier)) throw new InvalidOperationException($"Identifier uniqueness violation: '{identifier}'");
        _objects.Add(obj);
    }

    public void SetMainObject(Object obj)
    {
        if (!_objects.Contains(obj)) throw new InvalidOperationException("The main object has to be added to the asset first");
        mainObject = obj;
    }

    public void GetObjects(List<Object> objects)
    {
        objects.Clear();
        objects.AddRange(_objects);
    }

    public void DependsOnArtifact(string path) => ArtifactDependencies.Add(Checked(path));
    public void DependsOnSourceAsset(string path) => SourceDependencies.Add(Checked(path));
    public void LogImportError(string msg, Object obj = null) => Errors.Add(msg);
    public void LogImportWarning(string msg, Object obj = null) => Warnings.Add(msg);

    // Unity identifies an object in a hierarchy by the names on its path, so these paths must be unique.
    internal void CheckPaths()
    {
        foreach (var made in _objects)
            if (made is GameObject root) CheckPaths(root.transform, root.name);
    }

    void CheckPaths(Transform parent, string path)
    {
        var names = new HashSet<string>();
        foreach (Transform child in parent)
        {
            var childPath = path + "/" + child.name;
            if (!names.Add(child.name)) Warnings.Add($"Identifier uniqueness violation: 'Type:GameObject, Name:{childPath}'");
            CheckPaths(child, childPath);
        }
    }

    static string Checked(string path) =>
        string.IsNullOrEmpty(path) ? throw new ArgumentNullException(nameof(path), "Cannot add dependency on invalid path.") : path;
}

using Nowpose.UnityPlayer.Assets.Loading;
using Nowpose.UnityPlayer.Assets.Prefabs;

namespace Nowpose.UnityPlayer.Assets.Saving;

/// <summary>
/// Writes a hierarchy as the documents of a prefab or scene. These documents are objects with all their fields, and prefab instances with their
/// changes. This is the inverse of <see cref="HierarchyBuilder"/>.
/// </summary>
sealed class HierarchyWriter(string file)
{
    readonly FileIds _ids = new FileIds();
    readonly List<SavedObject> _saved = new List<SavedObject>();
    readonly Dictionary<PrefabInstance, PrefabInstance> _instances = new Dictionary<PrefabInstance, PrefabInstance>();

    /// <summary>Writes a hierarchy.</summary>
    /// <param name="assets">Assets to which the hierarchy may refer.</param>
    /// <param name="roots">Root objects; a prefab has one.</param>
    /// <param name="file">Name of the file in error messages.</param>
    /// <returns>The documents in the order of the hierarchy.</returns>
    public static IReadOnlyList<UnityDocument> Write(LoadedAssets assets, IReadOnlyList<GameObject> roots, string file)
    {
        var writer = new HierarchyWriter(file);
        foreach (var root in roots) writer.Collect(root);
        var references = new FileReferences(assets, writer._saved.ToDictionary(s => s.FileId, s => s.Target), roots);
        foreach (var saved in writer._saved) saved.Write(references);
        return writer.Documents().ToList();
    }

    void Collect(GameObject gameObject)
    {
        Collect(gameObject, gameObject);
        foreach (var component in gameObject.GetComponents<Component>()) Collect(component, gameObject);
        foreach (Transform child in gameObject.transform) Collect(child.gameObject);
    }

    void Collect(Object target, GameObject owner)
    {
        var origin = PrefabOrigin.Of(target);
        if (origin == null)
        {
            _saved.Add(new SavedObject(target, _ids.Next(KeyOf(target, owner)), null));
            return;
        }
        if (!_instances.TryGetValue(origin.Instance, out var instance))
        {
            var id = _ids.Next("PrefabInstance " + FileIds.PathOf(owner));
            _instances.Add(origin.Instance, instance = new PrefabInstance(file, id, origin.Instance.SourceGuid, origin.Instance.Source));
        }
        _saved.Add(new SavedObject(target, instance.Map(origin.SourceFileId), new PrefabLink(instance, origin.SourceFileId)));
    }

    static string KeyOf(Object target, GameObject owner)
    {
        var type = target.GetType();
        var place = type.Name + " " + FileIds.PathOf(owner);
        var number = target is Component ? owner.GetComponents(type).TakeWhile(c => c != target).Count() : 0;
        return number == 0 ? place : place + " " + Numbers.Write(number);
    }

    IEnumerable<UnityDocument> Documents()
    {
        var instances = _instances.Values.ToDictionary(i => i, i => new InstanceWriter(i, _saved));
        var referred = _saved.Where(s => s.Link == null).SelectMany(s => LocalReferences.In(s.Fields))
            .Concat(instances.Values.SelectMany(i => LocalReferences.In(i.Document.Fields))).ToHashSet();
        var begun = new HashSet<PrefabInstance>();
        foreach (var saved in _saved)
        {
            if (saved.Link == null)
            {
                yield return saved.Document();
                continue;
            }
            if (begun.Add(saved.Link.Instance)) yield return instances[saved.Link.Instance].Document;
            if (referred.Contains(saved.FileId)) yield return saved.Stripped();
        }
    }
}

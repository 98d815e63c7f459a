using Nowpose.UnityPlayer.Assets.Prefabs;

namespace Nowpose.UnityPlayer.Assets.Saving;

/// <summary>Finds the differences between a prefab instance and its prefab, and writes the document of the instance.</summary>
sealed class InstanceWriter
{
    /// <summary>Fields of the root of an instance that are always written, as in Unity.</summary>
    static readonly string[] Always = { "m_RootOrder", "m_LocalPosition", "m_LocalRotation", "m_LocalEulerAnglesHint", "m_Name" };

    readonly PrefabInstance _instance;
    readonly Dictionary<long, SavedObject> _saved;
    readonly HashSet<Object> _targets;

    public InstanceWriter(PrefabInstance instance, IEnumerable<SavedObject> saved)
    {
        _instance = instance;
        _saved = saved.Where(s => s.Link?.Instance == instance).ToDictionary(s => s.Link.SourceFileId);
        _targets = _saved.Values.Select(s => s.Target).ToHashSet();
        Document = Write();
    }

    public UnityDocument Document { get; }

    UnityDocument Write()
    {
        var source = _instance.Source.Objects;
        var present = source.Where(o => _saved.ContainsKey(o.FileId)).ToList();
        var modifications = present.SelectMany(o => ModificationsOf(o).Select(m => m.Write(_saved[o.FileId].Source())));
        var root = present.Select(o => _saved[o.FileId].Target).OfType<Transform>().First(IsRoot);
        AssetReference.TryRead(Nodes.Find(_saved.Values.First(s => s.Target == root).Fields, "m_Father"), out var father);
        return new UnityDocument(PrefabInstance.ClassId, "PrefabInstance", _instance.FileId, Nodes.Lines(
            ("m_ObjectHideFlags", Nodes.Number(0)),
            ("serializedVersion", Nodes.Number(2)),
            ("m_Modification", Nodes.Lines(
                ("m_TransformParent", father.Write()),
                ("m_Modifications", new YamlSequenceNode(modifications)),
                ("m_RemovedComponents", new YamlSequenceNode(source.Except(present).Select(Removed))))),
            ("m_SourcePrefab", new AssetReference(PrefabInstance.PrefabFileId, _instance.SourceGuid, AssetReference.Imported).Write())));
    }

    IEnumerable<Modification> ModificationsOf(FileObject source)
    {
        var saved = _saved[source.FileId];
        var changed = Modifications.Between(source.In(_instance), saved.Fields).ToList();
        if (!IsRoot(saved.Target)) return changed;
        // These fields are written even if they are unchanged.
        var always = Always.Where(name => Nodes.Find(saved.Fields, name) != null)
            .SelectMany(name => Modifications.All(Nodes.Find(saved.Fields, name), name)).ToList();
        return always.Concat(changed.Where(c => always.All(a => a.Path != c.Path)));
    }

    /// <summary>Returns whether an object is the root Transform or the root GameObject of the instance.</summary>
    bool IsRoot(Object target)
    {
        var transform = target is GameObject gameObject ? gameObject.transform : target as Transform;
        return transform != null && (transform.parent == null || !_targets.Contains(transform.parent));
    }

    YamlNode Removed(FileObject source)
    {
        if (source.IsTransform || source.ClassName == "GameObject")
            throw source.Place.Error(AssetFault.Hierarchy, "is missing in an instance; only components can be removed there");
        return new AssetReference(source.FileId, _instance.SourceGuid, AssetReference.Imported).Write();
    }
}

using Nowpose.UnityPlayer.Assets.Objects;
using Nowpose.UnityPlayer.Assets.Prefabs;

namespace Nowpose.UnityPlayer.Assets.Loading;

/// <summary>
/// Creates the objects of a prefab or scene. They are not in a scene yet, and their scripts have not received Awake. First creates all objects
/// with their components and parents; then sets the fields, which may refer to any of these objects.
/// </summary>
sealed class HierarchyBuilder(LoadedAssets assets, ObjectFile file, PrefabInstance whole)
{
    readonly Dictionary<long, Object> _objects = new Dictionary<long, Object>();
    readonly Dictionary<long, ObjectClass> _classes = new Dictionary<long, ObjectClass>();

    /// <summary>The created objects by fileID.</summary>
    public IReadOnlyDictionary<long, Object> Objects => _objects;

    public IReadOnlyList<GameObject> Roots { get; private set; }

    /// <summary>Creates the objects of a file.</summary>
    /// <param name="assets">Assets to which the file may refer.</param>
    /// <param name="file">Descriptions of the objects.</param>
    /// <param name="whole">Prefab instance that the new objects form; null if they are the objects of the file itself.</param>
    /// <param name="made">Called after the creation of all objects, before their fields are set.</param>
    public static HierarchyBuilder Build(
        LoadedAssets assets, ObjectFile file, PrefabInstance whole = null, Action<HierarchyBuilder> made = null)
    {
        var builder = new HierarchyBuilder(assets, file, whole);
        builder.MakeObjects();
        builder.MakeHierarchy();
        made?.Invoke(builder);
        builder.ReadFields();
        return builder;
    }

    IEnumerable<FileObject> GameObjects => file.Objects.Where(o => o.ClassName == "GameObject");

    IEnumerable<FileObject> Transforms => file.Objects.Where(o => o.IsTransform);

    void MakeObjects()
    {
        foreach (var described in GameObjects)
        {
            var made = GameObject.Detached("");
            Add(described, EngineClasses.Find(described.ClassId, described.ClassName), made);
            var components = described.Place.In("m_Component").Sequence(Nodes.Find(described.Fields, "m_Component")).Children;
            for (var i = 0; i < components.Count; i++) MakeComponent(ComponentAt(described, components[i]), made, isFirst: i == 0);
        }
        foreach (var described in file.Objects.Where(o => !_objects.ContainsKey(o.FileId)))
            throw described.Place.Error(
                AssetFault.Hierarchy, "is a component that no GameObject lists, or has a class that the stand-in does not support");
    }

    FileObject ComponentAt(FileObject owner, YamlNode entry)
    {
        var place = owner.Place.In("m_Component");
        if (!AssetReference.TryRead(Nodes.Find(place.Mapping(entry), "component"), out var reference) || reference.Guid != null)
            throw place.Error(AssetFault.Kind, "has to be a list of - component: {fileID: …}");
        var component = file.Find(reference.FileId)
            ?? throw place.Error(AssetFault.MissingObject, "the file has no object " + Numbers.Write(reference.FileId));
        if (component.Reference("m_GameObject").FileId != owner.FileId)
        {
            throw component.Place.In("m_GameObject")
                .Error(AssetFault.Hierarchy, "differs from the object that lists this component, &" + Numbers.Write(owner.FileId));
        }
        return component;
    }

    void MakeComponent(FileObject described, GameObject owner, bool isFirst)
    {
        if (_objects.ContainsKey(described.FileId)) throw described.Place.Error(AssetFault.Duplicate, "is listed twice as a component");
        if (isFirst != described.IsTransform)
            throw described.Place.Error(AssetFault.Hierarchy, "a GameObject must have exactly one Transform, as its first component");
        var known = described.ClassName == ScriptClass.ClassName
            ? ScriptClass.Of(assets.ScriptAt(described, typeof(MonoBehaviour)))
            : EngineClasses.Find(described.ClassId, described.ClassName)
                ?? throw described.Place.Error(AssetFault.Unsupported, "the stand-in does not support class "
                    + described.ClassName + " with number " + Numbers.Write(described.ClassId));
        var component = owner.Add(known.Type);
        if (component is OpaqueComponent opaque) opaque.ClassName = described.ClassName;
        Add(described, known, component);
    }

    void Add(FileObject described, ObjectClass known, Object made)
    {
        _objects.Add(described.FileId, made);
        _classes.Add(described.FileId, known);
        if (whole != null) PrefabOrigin.Set(made, new PrefabLink(whole, described.FileId));
        else if (described.Link != null) PrefabOrigin.Set(made, described.Link);
    }

    void MakeHierarchy()
    {
        var roots = new List<(int Order, GameObject Root)>();
        foreach (var described in Transforms)
        {
            var father = described.Reference("m_Father").FileId;
            if (father == 0) roots.Add((RootOrder(described), ((Transform)_objects[described.FileId]).gameObject));
            else if (!ChildrenOf(TransformAt(father, described)).Contains(described.FileId))
                throw described.Place.In("m_Father").Error(AssetFault.Hierarchy, "&" + Numbers.Write(father) + " does not list it in m_Children");
            foreach (var child in ChildrenOf(described)) Adopt(described, TransformAt(child, described));
        }
        Roots = roots.OrderBy(r => r.Order).Select(r => r.Root).ToList();
        var reached = Roots.Sum(r => r.GetComponentsInChildren<Transform>(true).Length);
        if (reached != Transforms.Count()) throw new AssetException(AssetFault.Hierarchy, file.Name + ": some objects are their own ancestors");
    }

    void Adopt(FileObject father, FileObject child)
    {
        if (child.Reference("m_Father").FileId != father.FileId)
            throw child.Place.In("m_Father").Error(AssetFault.Hierarchy, "is not &" + Numbers.Write(father.FileId)
                + ", which lists it in m_Children");
        ((Transform)_objects[child.FileId]).SetParent((Transform)_objects[father.FileId], false);
    }

    static List<long> ChildrenOf(FileObject transform)
    {
        var place = transform.Place.In("m_Children");
        var children = LocalReferences.In(place.Sequence(Nodes.Find(transform.Fields, "m_Children"))).ToList();
        return children.Distinct().Count() == children.Count ? children : throw place.Error(AssetFault.Duplicate, "lists a child twice");
    }

    FileObject TransformAt(long fileId, FileObject from) =>
        file.Find(fileId) is { IsTransform: true } found
            ? found
            : throw from.Place.Error(AssetFault.MissingObject, "&" + Numbers.Write(fileId) + " is not a Transform of this file");

    static int RootOrder(FileObject root)
    {
        var order = Nodes.Find(root.Fields, "m_RootOrder");
        if (order == null) return 0;
        var place = root.Place.In("m_RootOrder");
        return Numbers.TryRead(place.Scalar(order), out long index) ? (int)index : throw place.Error(AssetFault.Kind, "has to be a number");
    }

    void ReadFields()
    {
        var references = new FileReferences(assets, _objects, Roots);
        foreach (var described in file.Objects)
        {
            var made = _objects[described.FileId];
            var known = _classes[described.FileId];
            known.Read(described.Fields, made, references, described.PlaceAs(known.Type.Name));
            if (made is Transform transform) transform.MarkMoved();
        }
    }
}

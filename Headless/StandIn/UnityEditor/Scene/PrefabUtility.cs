using System.Runtime.CompilerServices;

namespace UnityEditor;

public sealed class PrefabUtility
{
    static readonly ConditionalWeakTable<Object, Object> Sources = new ConditionalWeakTable<Object, Object>();

    public static Object InstantiatePrefab(Object assetComponentOrGameObject)
    {
        var instance = Object.Instantiate(assetComponentOrGameObject);
        instance.name = assetComponentOrGameObject.name;
        Sources.Add(instance, assetComponentOrGameObject);
        return instance;
    }

    /// <summary>Prefab instances whose changes were recorded.</summary>
    internal static List<Object> Recorded { get; } = new List<Object>();

    public static void RecordPrefabInstancePropertyModifications(Object targetObject) => Recorded.Add(targetObject);

    /// <summary>Returns the topmost prefab instance that contains an object; null if no prefab instance contains it.</summary>
    public static GameObject GetOutermostPrefabInstanceRoot(Object componentOrGameObject)
    {
        GameObject outermost = null;
        for (var at = TransformOf(componentOrGameObject); at != null; at = at.parent)
            if (Sources.TryGetValue(at.gameObject, out _)) outermost = at.gameObject;
        return outermost;
    }

    public static void UnpackPrefabInstance(GameObject instanceRoot, PrefabUnpackMode unpackMode, InteractionMode action)
    {
        if (GetOutermostPrefabInstanceRoot(instanceRoot) != instanceRoot)
            throw new ArgumentException("The object is not the outermost root of a prefab instance", nameof(instanceRoot));
        Sources.Remove(instanceRoot);
    }

    static Transform TransformOf(Object part) => part is Component component ? component.transform : ((GameObject)part).transform;

    public static TObject GetCorrespondingObjectFromSource<TObject>(TObject componentOrGameObject) where TObject : Object =>
        Sources.TryGetValue(componentOrGameObject, out var source) ? (TObject)source : null;
}

public enum InteractionMode
{
    AutomatedAction = 0,
    UserAction = 1,
}

public enum PrefabUnpackMode
{
    OutermostRoot = 0,
    Completely = 1,
}

using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Object = UnityEngine.Object;

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

    public static TObject GetCorrespondingObjectFromSource<TObject>(TObject componentOrGameObject) where TObject : Object =>
        Sources.TryGetValue(componentOrGameObject, out var source) ? (TObject)source : null;
}

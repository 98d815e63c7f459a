namespace UnityEngine;

static class Hierarchy
{
    /// <summary>Adds an object and all its descendants to a list, parents before their children.</summary>
    internal static void Collect(GameObject top, List<GameObject> into)
    {
        into.Add(top);
        var transform = top.transform;
        for (var i = 0; i < transform.childCount; i++) Collect(transform.GetChild(i).gameObject, into);
    }
}

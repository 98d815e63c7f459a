using System.Collections.Generic;

namespace UnityEngine;

static class Hierarchy
{
    /// <summary>Adds the object and all below it, parents before children.</summary>
    internal static void Collect(GameObject top, List<GameObject> into)
    {
        into.Add(top);
        var transform = top.transform;
        for (var i = 0; i < transform.childCount; i++) Collect(transform.GetChild(i).gameObject, into);
    }
}

using UnityEngine;

namespace Nowpose.Prefabs;

/// <summary>Creates empty objects below others.</summary>
static class Children
{
    /// <param name="place">Position in the parent's frame.</param>
    public static GameObject Add(string name, Transform parent, Vector3 place = default)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent, worldPositionStays: false);
        child.transform.localPosition = place;
        return child;
    }
}

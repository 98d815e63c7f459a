using UnityEngine;

namespace UnityEditor;

public sealed class GameObjectUtility
{
    public static void SetParentAndAlign(GameObject child, GameObject parent)
    {
        if (!parent) return;

        child.transform.SetParent(parent.transform, false);
        child.layer = parent.layer;
    }
}

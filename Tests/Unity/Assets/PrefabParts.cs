using UnityEngine;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Creates objects that tests save as prefabs.</summary>
static class PrefabParts
{
    public static GameObject NewHand()
    {
        var hand = new GameObject("Hand");
        var probe = hand.AddComponent<LoaderProbe>();
        probe.number = 7;
        probe.text = "of the prefab";
        probe.parts.Add(new LoaderProbePart { name = "first", size = 1 });
        probe.parts.Add(new LoaderProbePart { name = "second", size = 2 });
        probe.other = NewChild("Finger", hand.transform);
        NewChild("Finger", hand.transform).localPosition = new Vector3(0.1f, 0, 0);
        return hand;
    }

    public static GameObject Below(GameObject parent, GameObject child, string name)
    {
        child.name = name;
        child.transform.SetParent(parent.transform, false);
        return child;
    }

    public static Transform NewChild(string name, Transform parent)
    {
        var child = new GameObject(name).transform;
        child.SetParent(parent, false);
        return child;
    }
}

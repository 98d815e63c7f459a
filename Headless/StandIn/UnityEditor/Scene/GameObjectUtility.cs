namespace UnityEditor;

public sealed class GameObjectUtility
{
    public static void SetParentAndAlign(GameObject child, GameObject parent)
    {
        if (!parent) return;

        child.transform.SetParent(parent.transform, false);
        child.layer = parent.layer;
    }

    /// <summary>Adds a number in parentheses to the name if a sibling, or another root object, has the same name.</summary>
    public static void EnsureUniqueNameForSibling(GameObject self)
    {
        var siblings = self.transform.parent == null
            ? self.scene.GetRootGameObjects()
            : Enumerable.Range(0, self.transform.parent.childCount).Select(i => self.transform.parent.GetChild(i).gameObject);
        var taken = siblings.Where(other => other != self).Select(other => other.name).ToHashSet();
        var name = self.name;
        for (var number = 1; taken.Contains(self.name); number++) self.name = $"{name} ({number})";
    }
}

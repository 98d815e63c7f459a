namespace Nowpose.Prefabs;

/// <summary>Creates objects below others.</summary>
static class Children
{
    /// <summary>Adds an empty object.</summary>
    /// <param name="place">Position in the parent's frame.</param>
    public static GameObject Add(string name, Transform parent, Vector3 place = default)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent, worldPositionStays: false);
        child.transform.localPosition = place;
        return child;
    }

    /// <summary>Adds an object with a built-in mesh of 1 m.</summary>
    /// <param name="parent">Parent of the object; null for a root object.</param>
    /// <param name="place">Position in the parent's frame.</param>
    /// <param name="size">Size along the object's axes, in units of the parent.</param>
    public static GameObject AddPrimitive(PrimitiveType type, string name, Transform parent, Vector3 place, Vector3 size, Material material)
    {
        var child = GameObject.CreatePrimitive(type);
        child.name = name;
        child.transform.SetParent(parent, worldPositionStays: false);
        child.transform.localPosition = place;
        child.transform.localScale = size;
        child.GetComponent<MeshRenderer>().sharedMaterial = material;
        return child;
    }
}

namespace UnityEngine;

public sealed partial class GameObject
{
    public static GameObject Find(string name)
    {
        foreach (var gameObject in World.Current.Scenes.GameObjects())
        {
            if (!gameObject.activeInHierarchy) continue;

            if (gameObject.name == name || Path(gameObject.transform) == name.TrimStart('/')) return gameObject;
        }

        return null;
    }

    public static GameObject CreatePrimitive(PrimitiveType type)
    {
        var made = new GameObject(type.ToString());
        made.AddComponent<MeshFilter>().sharedMesh = BuiltIn.Mesh(type);
        made.AddComponent<MeshRenderer>().sharedMaterial = BuiltIn.DefaultMaterial;
        return made;
    }

    static string Path(Transform t) => t.parent is null ? t.name : Path(t.parent) + "/" + t.name;
}

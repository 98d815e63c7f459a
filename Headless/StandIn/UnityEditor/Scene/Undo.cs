namespace UnityEditor;

public class Undo
{
    /// <summary>Names of the undo steps, oldest first.</summary>
    internal static List<string> Steps { get; } = new List<string>();

    /// <summary>Objects that were created in undo steps.</summary>
    internal static List<Object> Created { get; } = new List<Object>();

    public static void RecordObject(Object objectToUndo, string name) => Steps.Add(name);

    public static void RecordObjects(Object[] objectsToUndo, string name) => Steps.Add(name);

    public static void RegisterCreatedObjectUndo(Object objectToUndo, string name)
    {
        Steps.Add(name);
        Created.Add(objectToUndo);
    }

    public static void DestroyObjectImmediate(Object objectToUndo)
    {
        Steps.Add("Destroy " + objectToUndo.name);
        Object.DestroyImmediate(objectToUndo);
    }

    public static T AddComponent<T>(GameObject gameObject) where T : Component
    {
        Steps.Add("Add " + typeof(T).Name);
        return gameObject.AddComponent<T>();
    }

    public static void SetTransformParent(Transform transform, Transform newParent, string name)
    {
        Steps.Add(name);
        transform.SetParent(newParent);
    }

    internal static void Clear()
    {
        Steps.Clear();
        Created.Clear();
    }
}

namespace UnityEditor;

public class CustomEditor : Attribute
{
    public CustomEditor(Type inspectedType) => InspectedType = inspectedType;

    internal Type InspectedType { get; }
}

namespace UnityEditor;

public class Editor : ScriptableObject, IPreviewable, IToolModeOwner
{
    SerializedObject _serializedObject;

    public Object target { get; set; }
    public Object[] targets { get; private set; } = Array.Empty<Object>();
    public SerializedObject serializedObject => _serializedObject ??= new SerializedObject(targets);

    public static Editor CreateEditor(Object targetObject) => CreateEditor(new[] { targetObject }, null);
    public static Editor CreateEditor(Object[] targetObjects) => CreateEditor(targetObjects, null);

    public static Editor CreateEditor(Object[] targetObjects, Type editorType)
    {
        var type = editorType ?? EditorTypes.For(targetObjects[0].GetType(), targetObjects.Length > 1);
        Pending = targetObjects;
        return (Editor)CreateInstance(type);
    }

    public Editor()
    {
        targets = Pending ?? targets;
        target = targets.Length == 0 ? null : targets[0];
        Pending = null;
    }

    // The targets of the next instance. They are set before its construction, because OnEnable of a derived class already reads them.
    static Object[] Pending { get; set; }

    public bool DrawDefaultInspector()
    {
        serializedObject.Update();
        foreach (var property in serializedObject.All()) EditorGUILayout.PropertyField(property);
        return serializedObject.ApplyModifiedProperties();
    }

    public virtual void OnInspectorGUI() => DrawDefaultInspector();

    public virtual bool RequiresConstantRepaint() => false;

    public void Repaint() { }
}

/// <summary>Base interface of <see cref="Editor"/>, as in Unity. The stand-in does not use it.</summary>
interface IPreviewable
{
}

/// <summary>Base interface of <see cref="Editor"/>, as in Unity. The stand-in does not use it.</summary>
interface IToolModeOwner
{
}

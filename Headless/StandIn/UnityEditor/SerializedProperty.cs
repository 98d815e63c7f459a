using System.Collections;

namespace UnityEditor;

public class SerializedProperty : IDisposable
{
    readonly Type _type;
    readonly Func<object, object> _get;
    readonly Action<object, object> _set;

    internal SerializedProperty(SerializedObject owner, string path, Type type, Func<object, object> get, Action<object, object> set)
    {
        serializedObject = owner;
        propertyPath = path;
        _type = type;
        _get = get;
        _set = set;
    }

    public SerializedObject serializedObject { get; }
    public string propertyPath { get; }

    public bool hasMultipleDifferentValues => serializedObject.targetObjects.Any(o => !Equals(_get(o), Value));

    /// <summary>Drawer that draws the property; null if the editor draws it as a plain field.</summary>
    internal PropertyDrawer Drawer { get; set; }

    public int arraySize
    {
        get => ((IList)Value)?.Count ?? 0;
        set => throw new NotSupportedException("the stand-in cannot resize a list");
    }

    public int intValue
    {
        get => Convert.ToInt32(Value, System.Globalization.CultureInfo.InvariantCulture);
        set => Set(_type.IsEnum ? Enum.ToObject(_type, value) : value);
    }

    public bool boolValue
    {
        get => (bool)Value;
        set => Set(value);
    }

    public float floatValue
    {
        get => (float)Value;
        set => Set(value);
    }

    public Color colorValue
    {
        get => (Color)Value;
        set => Set(value);
    }

    public string stringValue
    {
        get => (string)Value;
        set => Set(value);
    }

    public Object objectReferenceValue
    {
        get => (Object)Value;
        set => Set(value);
    }

    object Value => _get(serializedObject.targetObject);

    public SerializedProperty GetArrayElementAtIndex(int index)
    {
        var element = _type.IsArray ? _type.GetElementType() : _type.GetGenericArguments()[0];
        return new SerializedProperty(
            serializedObject, $"{propertyPath}.Array.data[{index}]", element,
            o => ((IList)_get(o))[index], (o, value) => ((IList)_get(o))[index] = value);
    }

    public void Dispose() { }

    void Set(object value)
    {
        serializedObject.Change(() =>
        {
            foreach (var target in serializedObject.targetObjects) _set(target, value);
        });
    }
}

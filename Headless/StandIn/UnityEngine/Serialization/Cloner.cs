namespace UnityEngine.Serialization;

/// <summary>
/// Implements Object.Instantiate: copies the fields that Unity serialises. References to objects of the copied hierarchy are replaced with references
/// to their copies.
/// </summary>
sealed class Cloner
{
    readonly Dictionary<Object, Object> _copies = new();

    Cloner() { }

    internal static Object Instantiate(Object original, Transform parent, bool worldPositionStays)
    {
        if (!original) throw new ArgumentException("The Object you want to instantiate is null.", nameof(original));

        var source = original is Component component ? component.gameObject : original as GameObject;
        var cloner = new Cloner();
        if (source is null) cloner.CopyAsset((ScriptableObject)original);
        else cloner.CopyHierarchy(source, parent, worldPositionStays);
        return cloner._copies[original];
    }

    void CopyAsset(ScriptableObject source)
    {
        var copy = ScriptableObject.CreateAsleep(source.GetType());
        _copies.Add(source, copy);
        CopyAllFields();
        copy.name = source.name + "(Clone)";
        copy.Wake();
    }

    void CopyHierarchy(GameObject source, Transform parent, bool worldPositionStays)
    {
        var copy = CopyObjects(source, null);
        copy.name = source.name + "(Clone)";
        CopyAllFields();
        copy.transform.Attach(parent, worldPositionStays);
        if (copy.transform.parent is null) World.Current.Scenes.Active.Adopt(new[] { copy });
        else Lifecycle.Refresh(copy);
    }

    GameObject CopyObjects(GameObject source, Transform parent)
    {
        var copy = GameObject.Detached(source.name);
        copy.layer = source.layer;
        copy.tag = source.tag;
        copy.SetActiveSelf(source.activeSelf);
        _copies.Add(source, copy);
        foreach (var component in source.Components) _copies.Add(component, copy.Add(component.GetType()));
        copy.transform.Attach(parent, false);
        for (var i = 0; i < source.transform.childCount; i++) CopyObjects(source.transform.GetChild(i).gameObject, copy.transform);
        return copy;
    }

    void CopyAllFields()
    {
        foreach (var (source, copy) in _copies)
        {
            if (source is GameObject) continue;

            (source as ISerializationCallbackReceiver)?.OnBeforeSerialize();
            CopyFields(source, copy);
            (copy as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }
    }

    void CopyFields(object source, object copy)
    {
        foreach (var field in SerializedFields.Of(source.GetType())) field.SetValue(copy, CopyOf(field.GetValue(source), field.FieldType));
    }

    object CopyOf(object value, Type type)
    {
        if (typeof(Object).IsAssignableFrom(type)) return value is Object o && _copies.TryGetValue(o, out var copy) ? copy : value;
        if (type == typeof(string)) return value ?? "";
        if (type.IsArray) return CopyOfArray((Array)value, type.GetElementType());
        if (SerializedFields.IsList(type)) return CopyOfList((System.Collections.IList)value, type);
        if (!SerializedFields.IsNested(type) || SerializedFields.IsEngineValue(type)) return value;

        // Unity cannot serialise null for these types, so the copy always contains an object.
        var made = Activator.CreateInstance(type, nonPublic: true);
        if (value != null)
        {
            (value as ISerializationCallbackReceiver)?.OnBeforeSerialize();
            CopyFields(value, made);
            (made as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }

        return made;
    }

    Array CopyOfArray(Array source, Type element)
    {
        var copy = Array.CreateInstance(element, source?.Length ?? 0);
        for (var i = 0; i < copy.Length; i++) copy.SetValue(CopyOf(source.GetValue(i), element), i);
        return copy;
    }

    object CopyOfList(System.Collections.IList source, Type type)
    {
        var copy = (System.Collections.IList)Activator.CreateInstance(type);
        for (var i = 0; i < (source?.Count ?? 0); i++) copy.Add(CopyOf(source[i], type.GetGenericArguments()[0]));
        return copy;
    }
}

namespace UnityEngine;

public class ScriptableObject : Object
{
    public static ScriptableObject CreateInstance(Type type)
    {
        var made = CreateAsleep(type);
        made.Wake();
        return made;
    }

    public static T CreateInstance<T>() where T : ScriptableObject => (T)CreateInstance(typeof(T));

    /// <summary>Creates an object without calling Awake and OnEnable. The caller sets its fields and then calls <see cref="Wake"/>.</summary>
    internal static ScriptableObject CreateAsleep(Type type) => (ScriptableObject)Construction.Create(type);

    internal void Wake()
    {
        RareMessages.Call(this, "Awake");
        RareMessages.Call(this, "OnEnable");
    }

    internal void Sleep()
    {
        RareMessages.Call(this, "OnDisable");
        RareMessages.Call(this, "OnDestroy");
    }
}

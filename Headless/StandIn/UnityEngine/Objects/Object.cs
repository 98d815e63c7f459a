namespace UnityEngine;

public partial class Object
{
    readonly int _instanceId;
    string _name = "";
    HideFlags _hideFlags;

    public Object()
    {
        World = World.Current;
        _instanceId = World.NextId();
        World.Register(this);
    }

    public string name
    {
        get
        {
            ThrowIfDestroyed();
            return NameOwner._name;
        }
        set
        {
            ThrowIfDestroyed();
            NameOwner._name = value ?? "";
        }
    }

    public HideFlags hideFlags
    {
        get
        {
            ThrowIfDestroyed();
            return _hideFlags;
        }
        set
        {
            ThrowIfDestroyed();
            _hideFlags = value;
        }
    }

    /// <summary>World in which the object was created.</summary>
    internal World World { get; }

    internal bool Destroyed { get; private set; }

    /// <summary>Whether the object is an asset. Destroy rejects assets, so that scripts cannot destroy them by mistake.</summary>
    internal bool IsAsset { get; private set; }

    /// <summary>Object that stores the name of this object: for a component, its GameObject; otherwise the object itself.</summary>
    internal virtual Object NameOwner => this;

    public int GetInstanceID() => _instanceId;

    public static implicit operator bool(Object exists) => Alive(exists);
    public static bool operator ==(Object x, Object y) => Alive(x) ? ReferenceEquals(x, y) : !Alive(y);
    public static bool operator !=(Object x, Object y) => !(x == y);
    public override bool Equals(object other) => other is null ? Destroyed : other is Object o && this == o;
    public override int GetHashCode() => _instanceId;
    public override string ToString() => Destroyed ? "null" : $"{name} ({GetType().FullName})";

    public static void Destroy(Object obj)
    {
        if (Alive(obj)) obj.World.Destruction.Later(obj);
    }

    public static void DestroyImmediate(Object obj) => DestroyImmediate(obj, false);

    public static void DestroyImmediate(Object obj, bool allowDestroyingAssets)
    {
        if (Alive(obj)) obj.World.Destruction.Now(obj, allowDestroyingAssets);
    }

    internal static bool Alive(Object o) => o is not null && !o.Destroyed;

    internal void BecomeAsset()
    {
        IsAsset = true;
        World.Forget(this);
    }

    internal void ThrowIfDestroyed()
    {
        if (Destroyed)
        {
            throw new MissingReferenceException(
                $"The object of type '{GetType().Name}' has been destroyed but you are still trying to access it.\n" +
                "Your script should either check if it is null or you should not destroy the object.");
        }
    }

    /// <summary>Marks the object as destroyed. It equals null afterwards.</summary>
    internal void MarkDestroyed()
    {
        Destroyed = true;
        World.Forget(this);
    }
}

using System.Collections;

namespace UnityEngine;

/// <summary>The hierarchy part of the class: parent and children of an object. The other part of the class contains the pose.</summary>
public partial class Transform : Component, IEnumerable
{
    readonly List<Transform> _children = new();
    Transform _parent;

    protected Transform() { }

    public Transform parent
    {
        get
        {
            ThrowIfDestroyed();
            return _parent;
        }
        set => SetParent(value);
    }

    public Transform root
    {
        get
        {
            ThrowIfDestroyed();
            var top = this;
            while (top._parent != null) top = top._parent;
            return top;
        }
    }

    public int childCount
    {
        get
        {
            ThrowIfDestroyed();
            return _children.Count;
        }
    }

    public Transform GetChild(int index)
    {
        ThrowIfDestroyed();
        return index >= 0 && index < _children.Count ? _children[index] : throw new UnityException("Transform child out of bounds");
    }

    public IEnumerator GetEnumerator() => _children.ToArray().GetEnumerator();

    public void SetParent(Transform p) => SetParent(p, true);

    public void SetParent(Transform parent, bool worldPositionStays)
    {
        var before = _parent;
        Attach(parent, worldPositionStays);
        Lifecycle.Refresh(Owner);
        if (!ReferenceEquals(_parent, before)) Lifecycle.ReportNewParent(Owner);
    }

    /// <summary>Sets the parent. Does not activate or deactivate objects.</summary>
    internal void Attach(Transform parent, bool worldPositionStays)
    {
        ThrowIfDestroyed();
        // A destroyed parent counts as null.
        if (!Alive(parent)) parent = null;
        if (ReferenceEquals(parent, _parent)) return;

        if (parent is not null && parent.IsChildOf(this))
        {
            Debug.LogError("Parenting would create a loop: a child cannot be the parent of its own parent.", this);
            return;
        }

        var place = worldPositionStays ? new WorldPlace(this) : default;
        Reparent(parent);
        MarkMoved();
        if (worldPositionStays) place.Restore(this);
    }

    public bool IsChildOf(Transform parent)
    {
        for (var t = this; t is not null; t = t._parent)
        {
            if (ReferenceEquals(t, parent)) return true;
        }

        return false;
    }

    /// <summary>Finds a child by its name, or a descendant by a path of names separated by slashes.</summary>
    public Transform Find(string n)
    {
        ThrowIfDestroyed();
        var slash = n.IndexOf('/');
        var head = slash < 0 ? n : n.Substring(0, slash);
        foreach (var child in _children)
        {
            if (child.name == head) return slash < 0 ? child : child.Find(n.Substring(slash + 1));
        }

        return null;
    }

    public int GetSiblingIndex() => _parent is null ? Owner.Content?.IndexOf(Owner) ?? 0 : _parent._children.IndexOf(this);

    /// <summary>Removes the transform from its parent or its scene, before it gets another parent or is destroyed.</summary>
    internal void Leave()
    {
        if (_parent is not null) _parent._children.Remove(this);
        else Owner.Content?.Remove(Owner);
    }

    void Reparent(Transform parent)
    {
        var scene = parent is null ? (_parent is null ? Owner.Content : _parent.Owner.Content) : parent.Owner.Content;
        Leave();
        _parent = parent;
        if (parent is not null) parent._children.Add(this);
        else scene?.Add(Owner);
        Owner.MoveTo(scene);
    }
}

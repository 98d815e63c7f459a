using System;
using System.Collections.Generic;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public sealed partial class GameObject : Object
{
    readonly List<Component> _components = new();

    public GameObject() : this("New Game Object") { }

    public GameObject(string name) : this(name, World.Current.Scenes.Active) => Lifecycle.Activate(this);

    public GameObject(string name, params Type[] components) : this(name)
    {
        foreach (var component in components) AddComponent(component);
    }

    GameObject(string name, SceneContent scene)
    {
        this.name = name;
        Content = scene;
        transform = (Transform)Add(typeof(Transform));
        scene?.Add(this);
    }

    public Transform transform
    {
        get
        {
            ThrowIfDestroyed();
            return field;
        }
        private set;
    }

    public GameObject gameObject => this;

    public int layer { get; set; }

    public string tag { get; set; } = "Untagged";

    public bool activeSelf { get; private set; } = true;

    public bool activeInHierarchy { get; private set; }

    public Scene scene
    {
        get
        {
            ThrowIfDestroyed();
            return new Scene(Content);
        }
    }

    /// <summary>In the order they were added, the Transform first.</summary>
    internal IReadOnlyList<Component> Components => _components;

    /// <summary>The scene it is in; null for a prefab and for what is still being put together.</summary>
    internal SceneContent Content { get; private set; }

    /// <summary>An object that is in no scene: nothing of it wakes until <see cref="SceneContent.Adopt"/>.</summary>
    internal static GameObject Detached(string name) => new(name, (SceneContent)null);

    public bool CompareTag(string tag) => this.tag == tag;

    public void SetActive(bool value)
    {
        ThrowIfDestroyed();
        if (activeSelf == value) return;

        activeSelf = value;
        Lifecycle.Refresh(this);
    }

    public Component AddComponent(Type componentType)
    {
        ThrowIfDestroyed();
        var required = Requirements.Of(componentType);
        if (required.Alone && GetComponent(componentType))
        {
            Debug.LogError(
                $"Can't add component '{componentType.Name}' to {name} because such a component is already added to the game object!", this);
            return null;
        }

        foreach (var type in required.Types)
        {
            if (!GetComponent(type)) AddComponent(type);
        }

        var component = Add(componentType);
        if (activeInHierarchy) component.Activated();
        return component;
    }

    public T AddComponent<T>() where T : Component => (T)AddComponent(typeof(T));

    /// <summary>Adds it and nothing else: no message, no required ones.</summary>
    internal Component Add(Type type)
    {
        if (_components.Count > 0 && typeof(Transform).IsAssignableFrom(type)) return TransformOf(type);

        var component = (Component)Construction.Create(type);
        component.AttachTo(this);
        _components.Add(component);
        return component;
    }

    /// <summary>One of a derived class takes the place of the Transform, as in Unity; here only before anything hangs on it.</summary>
    Transform TransformOf(Type type)
    {
        if (type.IsInstanceOfType(transform)) return transform;
        var replacing = (Transform)Construction.Create(type);
        replacing.AttachTo(this);
        _components[0] = replacing;
        transform = replacing;
        return replacing;
    }

    /// <summary>Sets the flag as a file does, before the object is in a scene.</summary>
    internal void SetActiveSelf(bool value) => activeSelf = value;

    internal void SetActiveInHierarchy(bool value) => activeInHierarchy = value;

    internal void Remove(Component component) => _components.Remove(component);

    /// <summary>Notes the scene, for it and all below it.</summary>
    internal void MoveTo(SceneContent scene)
    {
        Content = scene;
        for (var i = 0; i < transform.childCount; i++) transform.GetChild(i).gameObject.MoveTo(scene);
    }
}

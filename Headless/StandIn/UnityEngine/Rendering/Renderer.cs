using UnityEngine.Serialization;

namespace UnityEngine;

public class Renderer : Component
{
    [SerializeField, SerializedName("m_Enabled")] bool _enabled = true;
    [SerializeField, SerializedName("m_Materials")] Material[] _materials = new Material[1];
    [SerializeField, SerializedName("m_ReceiveShadows")] bool _receiveShadows = true;
    readonly MaterialPropertyBlock _block = new();
    readonly System.Collections.Generic.List<MaterialPropertyBlock> _blocks = new();
    Bounds? _bounds;

    public bool enabled
    {
        get
        {
            ThrowIfDestroyed();
            return _enabled;
        }
        set
        {
            ThrowIfDestroyed();
            _enabled = value;
        }
    }

    /// <summary>Axis-aligned box in the world that encloses the transformed bounding box of the mesh, as in Unity.</summary>
    public Bounds bounds
    {
        get
        {
            if (_bounds.HasValue) return _bounds.Value;

            var local = TryGetComponent<MeshFilter>(out var filter) && filter.sharedMesh ? filter.sharedMesh.bounds : default;
            var world = new Bounds(transform.TransformPoint(local.center), Vector3.zero);
            for (var i = 0; i < 8; i++)
            {
                var corner = new Vector3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
                world.Encapsulate(transform.TransformPoint(local.center + Vector3.Scale(corner, local.extents)));
            }

            return world;
        }
        set => _bounds = value;
    }

    public bool forceRenderingOff { get; set; }

    public bool isVisible => _enabled && !forceRenderingOff && gameObject.activeInHierarchy;

    public Material sharedMaterial
    {
        get
        {
            ThrowIfDestroyed();
            return _materials.Length > 0 ? _materials[0] : null;
        }
        set
        {
            ThrowIfDestroyed();
            if (_materials.Length == 0) _materials = new[] { value };
            else _materials[0] = value;
        }
    }

    public Material[] sharedMaterials
    {
        get => (Material[])_materials.Clone();
        set
        {
            // Copies into the existing array if possible, so that a change of the materials does not allocate.
            if (value.Length == _materials.Length) System.Array.Copy(value, _materials, value.Length);
            else _materials = (Material[])value.Clone();
        }
    }

    public void GetSharedMaterials(System.Collections.Generic.List<Material> m)
    {
        ThrowIfDestroyed();
        m.Clear();
        foreach (var material in _materials) m.Add(material);
    }

    public bool HasPropertyBlock() => !_block.isEmpty || _blocks.Exists(b => !b.isEmpty);

    public void SetPropertyBlock(MaterialPropertyBlock properties)
    {
        ThrowIfDestroyed();
        _block.CopyFrom(properties);
    }

    public void GetPropertyBlock(MaterialPropertyBlock properties)
    {
        ThrowIfDestroyed();
        properties.CopyFrom(_block);
    }

    /// <summary>Sets the block of one material, which replaces the block of the renderer for this material. Null removes it.</summary>
    public void SetPropertyBlock(MaterialPropertyBlock properties, int materialIndex)
    {
        ThrowIfDestroyed();
        while (_blocks.Count <= materialIndex) _blocks.Add(new MaterialPropertyBlock());
        _blocks[materialIndex].CopyFrom(properties);
    }

    public void GetPropertyBlock(MaterialPropertyBlock properties, int materialIndex)
    {
        ThrowIfDestroyed();
        properties.CopyFrom(materialIndex < _blocks.Count ? _blocks[materialIndex] : null);
    }
}

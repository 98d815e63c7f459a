using UnityEngine.Serialization;

namespace UnityEngine;

public partial class Transform
{
    [SerializeField, SerializedName("m_LocalPosition")] Vector3 _localPosition = Vector3.zero;
    [SerializeField, SerializedName("m_LocalRotation")] Quaternion _localRotation = Quaternion.identity;
    [SerializeField, SerializedName("m_LocalScale")] Vector3 _localScale = Vector3.one;

    // Cached pose in the world; valid while _known is true. _known becomes false when the transform or an ancestor moves.
    Matrix4x4 _matrix;
    Quaternion _rotation;
    bool _known;

    public Vector3 localPosition
    {
        get
        {
            ThrowIfDestroyed();
            return _localPosition;
        }
        set
        {
            ThrowIfDestroyed();
            _localPosition = value;
            MarkMoved();
        }
    }

    public Quaternion localRotation
    {
        get
        {
            ThrowIfDestroyed();
            return _localRotation;
        }
        set
        {
            ThrowIfDestroyed();
            _localRotation = Quaternion.Normalize(value);
            MarkMoved();
        }
    }

    public Vector3 localScale
    {
        get
        {
            ThrowIfDestroyed();
            return _localScale;
        }
        set
        {
            ThrowIfDestroyed();
            _localScale = value;
            MarkMoved();
        }
    }

    public Vector3 localEulerAngles
    {
        get => localRotation.eulerAngles;
        set => localRotation = Quaternion.Euler(value);
    }

    public Vector3 position
    {
        get => localToWorldMatrix.GetPosition();
        set => localPosition = _parent is null ? value : _parent.InverseTransformPoint(value);
    }

    public Quaternion rotation
    {
        get
        {
            Know();
            return _rotation;
        }
        set => localRotation = _parent is null ? value : Quaternion.Inverse(_parent.rotation) * value;
    }

    public Vector3 eulerAngles
    {
        get => rotation.eulerAngles;
        set => rotation = Quaternion.Euler(value);
    }

    /// <summary>Scale in the world. Not exact if the object is rotated relative to an ancestor with non-uniform scale.</summary>
    public Vector3 lossyScale
    {
        get
        {
            var scale = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * _matrix;
            return new Vector3(scale.m00, scale.m11, scale.m22);
        }
    }

    public Vector3 up
    {
        get => rotation * Vector3.up;
        set => rotation = Quaternion.FromToRotation(Vector3.up, value);
    }

    public Vector3 forward
    {
        get => rotation * Vector3.forward;
        set => rotation = Quaternion.LookRotation(value);
    }

    public Matrix4x4 localToWorldMatrix
    {
        get
        {
            Know();
            return _matrix;
        }
    }

    public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
    {
        this.position = position;
        this.rotation = rotation;
    }

    public Vector3 TransformPoint(Vector3 position) => localToWorldMatrix.MultiplyPoint3x4(position);
    public Vector3 TransformDirection(Vector3 direction) => rotation * direction;
    public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;

    public Vector3 InverseTransformPoint(Vector3 position)
    {
        ThrowIfDestroyed();
        // Converts level by level from the root, because the rounding errors of an inverse 4x4 float matrix are too large at positions of about 1 m.
        var above = _parent is null ? position : _parent.InverseTransformPoint(position);
        return Unscaled(Quaternion.Inverse(_localRotation) * (above - _localPosition));
    }

    /// <summary>Converts a vector from the world to the axes and the scale of this transform.</summary>
    internal Vector3 InverseVector(Vector3 vector)
    {
        var above = _parent is null ? vector : _parent.InverseVector(vector);
        return Unscaled(Quaternion.Inverse(_localRotation) * above);
    }

    /// <summary>Marks the cached pose as outdated. Must also be called after the pose fields were set directly.</summary>
    internal void MarkMoved()
    {
        if (!_known) return;

        // If this pose is already outdated, the poses of all descendants are also outdated.
        _known = false;
        foreach (var child in _children) child.MarkMoved();
    }

    void Know()
    {
        ThrowIfDestroyed();
        if (_known) return;

        var local = Matrix4x4.TRS(_localPosition, _localRotation, _localScale);
        _matrix = _parent is null ? local : _parent.localToWorldMatrix * local;
        _rotation = _parent is null ? _localRotation : Quaternion.Normalize(_parent.rotation * _localRotation);
        _known = true;
    }

    Vector3 Unscaled(Vector3 v) => new(Divided(v.x, _localScale.x), Divided(v.y, _localScale.y), Divided(v.z, _localScale.z));

    static float Divided(float value, float scale) => scale == 0 ? 0 : value / scale;
}

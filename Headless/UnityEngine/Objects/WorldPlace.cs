namespace UnityEngine;

/// <summary>Where something is in the world, to be kept while its parent changes.</summary>
readonly struct WorldPlace
{
    readonly Vector3 _position;
    readonly Quaternion _rotation;
    readonly Matrix4x4 _matrix;

    internal WorldPlace(Transform of)
    {
        _position = of.position;
        _rotation = of.rotation;
        _matrix = of.localToWorldMatrix;
    }

    /// <summary>Position and rotation are kept; the scale as well as three numbers can, which skew it cannot.</summary>
    internal void Restore(Transform to)
    {
        to.SetPositionAndRotation(_position, _rotation);
        var unscaled = to.parent is null ? Matrix4x4.Rotate(to.localRotation) : to.parent.localToWorldMatrix * Matrix4x4.Rotate(to.localRotation);
        var scale = unscaled.inverse * _matrix;
        to.localScale = new Vector3(scale.m00, scale.m11, scale.m22);
    }
}

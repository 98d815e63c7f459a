namespace UnityEngine;

/// <summary>Where something is in the world, to be kept while its parent changes.</summary>
readonly struct WorldPlace
{
    readonly Matrix4x4 _matrix;
    readonly Quaternion _rotation;

    internal WorldPlace(Transform of)
    {
        _matrix = of.localToWorldMatrix;
        _rotation = of.rotation;
    }

    /// <summary>Position and rotation are kept; the scale as well as three numbers can, which skew it cannot.</summary>
    internal void Restore(Transform to)
    {
        to.localScale = Vector3.one;
        to.SetPositionAndRotation(_matrix.GetPosition(), _rotation);
        to.localScale = new Vector3(
            to.InverseVector(_matrix.GetColumn(0)).x, to.InverseVector(_matrix.GetColumn(1)).y, to.InverseVector(_matrix.GetColumn(2)).z);
    }
}

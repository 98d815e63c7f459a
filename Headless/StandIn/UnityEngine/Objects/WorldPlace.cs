namespace UnityEngine;

/// <summary>Pose of an object in the world, stored while its parent changes.</summary>
readonly struct WorldPlace(Transform of)
{
    readonly Matrix4x4 _matrix = of.localToWorldMatrix;
    readonly Quaternion _rotation = of.rotation;

    /// <summary>Restores position, rotation and scale. The scale is approximate if the new parent would require a skew.</summary>
    internal void Restore(Transform to)
    {
        to.localScale = Vector3.one;
        to.SetPositionAndRotation(_matrix.GetPosition(), _rotation);
        to.localScale = new Vector3(
            to.InverseVector(_matrix.GetColumn(0)).x, to.InverseVector(_matrix.GetColumn(1)).y, to.InverseVector(_matrix.GetColumn(2)).z);
    }
}

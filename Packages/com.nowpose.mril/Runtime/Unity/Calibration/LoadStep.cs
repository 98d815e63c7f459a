namespace Nowpose.Unity.Calibration
{
    /// <summary>Kinds of steps that build a patch of a rendering load. Their durations differ.</summary>
    enum LoadStep
    {
        /// <summary>Computes some vertices of a patch and their triangles.</summary>
        Compute,

        /// <summary>Copies the vertices to the mesh of the patch.</summary>
        SetVertices,

        /// <summary>Copies the triangles to the mesh of the patch.</summary>
        SetTriangles,

        /// <summary>Uploads the mesh to the GPU and shows it.</summary>
        Show,
    }
}

namespace Nowpose.Unity.Calibration
{
    /// <summary>Kinds of steps in building a load; their durations differ.</summary>
    enum LoadStep
    {
        /// <summary>Computes some of a patch's vertices and their triangles.</summary>
        Compute,

        /// <summary>Sets the vertices of a patch's mesh.</summary>
        SetVertices,

        /// <summary>Sets the triangles of a patch's mesh.</summary>
        SetTriangles,

        /// <summary>Uploads the mesh to the GPU and shows it.</summary>
        Show,
    }
}

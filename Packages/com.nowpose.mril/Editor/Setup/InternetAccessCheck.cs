namespace Nowpose.Editor.Setup
{
    sealed class InternetAccessCheck : ProjectCheck
    {
        public InternetAccessCheck()
            : base(
                "Internet Access is Require", "Android refuses connections to an app without the permission; Unity adds the permission automatically only "
                + "if the app uses Unity's own network classes.", "Require internet access")
        { }

        public override CheckResult Look(IProjectSettings project) =>
            project.AsksForInternet ? Good("the app asks for it") : Missing("left to Unity");

        public override string Fix(IProjectSettings project)
        {
            project.AsksForInternet = true;
            return null;
        }
    }
}
